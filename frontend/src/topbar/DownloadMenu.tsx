import { useState } from "react";

import { Icon } from "../ui/Icon";
import { Popover } from "../ui/Popover";
import { download, type Download } from "./download";

const FILES: readonly { what: Download; title: string; text: string }[] = [
  { what: "mould-svg", title: "Mould, SVG", text: "Sheets for the laser cutter, true millimetres" },
  { what: "actuator-stl", title: "Actuator, STL", text: "Closed surface of the body, for printing and CAD" },
];

export function DownloadMenu() {
  const [busy, setBusy] = useState<Download | null>(null);
  return (
    <Popover
      label="Downloads"
      align="end"
      button={(open, toggle) => (
        <button
          type="button"
          className="button plain"
          aria-expanded={open}
          onClick={toggle}
          title="Files for cutting and printing"
          data-testid="open-downloads"
        >
          <Icon name="download" />
          <span>Files</span>
        </button>
      )}
    >
      {(close) => (
        <div className="menu">
          {FILES.map((file) => (
            <button
              key={file.what}
              type="button"
              className="menu-item"
              disabled={busy !== null}
              data-testid={`download-${file.what}`}
              onClick={() => {
                setBusy(file.what);
                void download(file.what).finally(() => {
                  setBusy(null);
                  close();
                });
              }}
            >
              <span className="menu-title">{file.title}</span>
              <span className="muted">{busy === file.what ? "Making the file" : file.text}</span>
            </button>
          ))}
        </div>
      )}
    </Popover>
  );
}
