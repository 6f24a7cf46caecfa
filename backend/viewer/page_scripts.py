"""What is put into viser's page: its own controls hidden, its console kept clean, one body in view,
and word of which bodies it has loaded and which it shows."""

# viser's own panel, notifications and mobile sheet are hidden: the page around the frame has
# controls of its own. So is the fade-in, which stands still half way while nothing moves.
HIDING = """<style>
[data-floating-window],[data-dock-region],.mantine-Notifications-root,.mantine-Paper-root
{display:none!important}
canvas[data-engine]{opacity:1!important}
html,body{margin:0;height:100%;overflow:hidden;background:transparent}
</style>"""
# viser's page starts a sorter for Gaussian splats at load, a WASM module whose glue (Embind) builds
# functions from strings. The policy refuses that, rightly; no splats are shown here, and nothing
# waits for the sorter. Its failure alone is kept off the console.
QUIET = """<script>
addEventListener("unhandledrejection", (event) => {
  if (event.reason instanceof EvalError) event.preventDefault();
});
</script>"""
# Bodies load behind the scenes, and nothing in viser says when. three.js shows its scenes to
# whoever calls itself its developer tools; from them the page reads how many bodies of each take
# are in place, and tells the room, which lets new bodies take the old ones' place only then.
# viser's page shows what it is told to at the next frame, but takes nodes away when its thread has
# time: of two takes in view only the newer one is drawn, and the page around is told which.
LOADED = """<script>
{
  const scenes = new Set(), told = new Map(), page = Math.random().toString(36);
  // takes by their age, and how long each has stayed behind a newer one that is in view
  const ages = new Map(), behind = new Map();
  let drawn = null;
  const takes = (scene) => {
    const found = [], walk = (node, visible) => {
      const on = visible && node.visible, {take} = node.userData;
      if (take) {
        if (!ages.has(take)) ages.set(take, ages.size);
        found.push({take, node, on});
      }
      for (const child of node.children) walk(child, on);
    };
    walk(scene, true);
    return found;
  };
  const newest = (found) => found.filter(({on}) => on).map(({take}) => take)
    .reduce((a, b) => (a !== null && ages.get(a) >= ages.get(b) ? a : b), null);
  const one = (scene) => {
    const found = takes(scene), shown = newest(found);
    if (shown === null) return;
    for (const {take, node, on} of found) if (on && take !== shown) node.visible = false;
    if (drawn !== shown) parent.postMessage({shown}, location.origin);
    drawn = shown;
  };
  // a take that stays behind was removed while it was being put in place, and belongs to nobody
  const tidy = (found) => {
    const left = new Set(found.map(({take}) => take));
    for (const take of left) if (!(ages.get(take) < ages.get(drawn))) left.delete(take);
    for (const take of behind.keys()) if (!left.has(take)) behind.delete(take);
    for (const take of left) behind.set(take, (behind.get(take) ?? 0) + 1);
    for (const {take, node} of found) if ((behind.get(take) ?? 0) > 25) node.removeFromParent();
  };
  window.__THREE_DEVTOOLS__ = new EventTarget();
  window.__THREE_DEVTOOLS__.addEventListener("observe", ({detail}) => {
    if (!detail.isScene) return;
    scenes.add(detail);
    const before = detail.onBeforeRender;
    detail.onBeforeRender = (...given) => { one(detail); before.apply(detail, given); };
  });
  setInterval(() => {
    const all = [...scenes].flatMap(takes), found = new Map();
    for (const {take} of all) found.set(take, (found.get(take) ?? 0) + 1);
    tidy(all);
    for (const take of told.keys()) if (!found.has(take)) told.delete(take);
    for (const [take, bodies] of found) {
      if (told.get(take) === bodies) continue;
      told.set(take, bodies);
      fetch("loaded", {method: "POST", headers: {"content-type": "application/json"},
                       body: JSON.stringify({take, bodies, page})})
        .catch(() => told.delete(take));
    }
  }, 40);
}
</script>"""
