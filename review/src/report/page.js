// n and j go to the next change, p and k to the one before.
addEventListener('keydown', (event) => {
  const step = { n: 1, j: 1, p: -1, k: -1 }[event.key];
  if (!step || event.ctrlKey || event.altKey || event.metaKey) return;
  const changes = [...document.querySelectorAll('.change')];
  const at = changes.indexOf(document.activeElement.closest('.change'));
  const next = changes[at < 0 ? (step > 0 ? 0 : changes.length - 1) : at + step];
  if (next) { next.focus(); next.scrollIntoView({ block: 'nearest' }); }
});
