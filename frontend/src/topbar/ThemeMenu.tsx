import { setThemeChoice, useTheme, type ThemeChoice } from "../theme/theme";
import { IconButton } from "../ui/Button";
import type { IconName } from "../ui/Icon";

const NEXT: Record<ThemeChoice, ThemeChoice> = { system: "light", light: "dark", dark: "system" };
const ICONS: Record<ThemeChoice, IconName> = { system: "auto", light: "sun", dark: "moon" };
const NAMES: Record<ThemeChoice, string> = { system: "as the system has it", light: "light", dark: "dark" };

export function ThemeMenu() {
  const { choice } = useTheme();
  return (
    <IconButton
      icon={ICONS[choice]}
      label={`Colours: ${NAMES[choice]}`}
      data-testid="theme"
      onClick={() => setThemeChoice(NEXT[choice])}
    />
  );
}
