/** Line icons on a 16 x 16 grid, drawn for this page. */
const PATHS = {
  undo: "M6 3 2.500 6.500 6 10M3 6.500h6.500a3.750 3.750 0 0 1 0 7.500H6",
  redo: "M10 3l3.500 3.500L10 10M13 6.500H6.500a3.750 3.750 0 0 0 0 7.500H10",
  save: "M3 2.500h8l2.500 2.500v8.500H2.500V3zM5 2.500v3.500h5V2.500M5 13.500V9.500h6v4",
  history: "M2.500 8a5.500 5.500 0 1 1 1.600 3.900M2.500 12.500V9.500h3M8 5v3l2 1.500",
  compare: "M6.500 3H2.500v10h4M9.500 3h4v10h-4M8 1.500v13",
  download: "M8 2v8M4.500 7 8 10.500 11.500 7M2.500 13.500h11",
  sun: "M8 5.200a2.800 2.800 0 1 0 0 5.600 2.800 2.800 0 0 0 0-5.600M8 1v1.500M8 13.500V15M1 8h1.500M13.500 8H15M3 3l1.100 1.100M11.900 11.900 13 13M13 3l-1.100 1.100M4.100 11.900 3 13",
  moon: "M13.500 9.500A5.800 5.800 0 0 1 6.500 2.500a5.800 5.800 0 1 0 7 7z",
  auto: "M8 2.200a5.800 5.800 0 1 0 0 11.600zM8 2.200a5.800 5.800 0 0 1 0 11.600",
  play: "M4.500 2.800v10.400l8.500-5.200z",
  pause: "M4.500 3v10M11.500 3v10",
  reset: "M3 8a5 5 0 1 0 1.600-3.700M3 2.500v3h3",
  close: "M3.500 3.500l9 9M12.500 3.500l-9 9",
  check: "M3 8.500l3.500 3.500L13 4.500",
  chevron: "M4 6l4 4 4-4",
  search: "M7 2.500a4.500 4.500 0 1 0 0 9 4.500 4.500 0 0 0 0-9M10.300 10.300 13.500 13.500",
  fork: "M4.500 2.500v4a2 2 0 0 0 2 2h3a2 2 0 0 1 2 2v3M4.500 6.500v7M3 3.500l1.500-1.500L6 3.500M10 12l1.500 1.500L13 12",
  archive: "M2.500 3h11v3h-11zM3.500 6v7.500h9V6M6.500 9h3",
  edit: "M10.500 2.800l2.700 2.700L6 12.700l-3.300.6.600-3.300z",
  layers: "M8 2 2 5.200 8 8.400l6-3.200zM2 8.500l6 3.200 6-3.200",
  eye: "M1.500 8S4 3.500 8 3.500 14.500 8 14.500 8 12 12.500 8 12.500 1.500 8 1.500 8zM8 6.200a1.800 1.800 0 1 0 0 3.600 1.800 1.800 0 0 0 0-3.600",
  warning: "M8 2 1.500 13.500h13zM8 6.500v3.300M8 11.400v.4",
  info: "M8 2a6 6 0 1 0 0 12A6 6 0 0 0 8 2zM8 7.200v4M8 4.800v.4",
  offline: "M2 2l12 12M4 6.300a6 6 0 0 1 1.500-.9M8 4.800a6.300 6.300 0 0 1 4.200 1.600M6 9a3.200 3.200 0 0 1 3.300-.5M8 12v.3",
  stop: "M4 4h8v8H4z",
  keyboard: "M1.500 4h13v8h-13zM4 6.700h.1M6.700 6.700h.1M9.300 6.700h.1M12 6.700h.1M5 9.500h6",
  plus: "M8 3v10M3 8h10",
} as const;

export type IconName = keyof typeof PATHS;

export function Icon({ name, size = 16 }: { name: IconName; size?: number }) {
  const filled = name === "play" || name === "stop";
  return (
    <svg
      className="icon"
      width={size}
      height={size}
      viewBox="0 0 16 16"
      aria-hidden="true"
      fill={filled ? "currentColor" : "none"}
      stroke="currentColor"
      strokeWidth={name === "pause" ? 2.6 : 1.4}
      strokeLinecap="round"
      strokeLinejoin="round"
    >
      <path d={PATHS[name]} />
    </svg>
  );
}
