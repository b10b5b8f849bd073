/// A new element. `text` becomes textContent, functions become listeners (`onclick`), the rest attributes. No markup.
export function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name === 'text') node.textContent = value;
    else if (typeof value === 'function') node.addEventListener(name.slice(2), value);
    else node.setAttribute(name, value === true ? '' : value);
  }
  node.append(...children);
  return node;
}

/// Sets text only if it differs: no work for the browser, no chatter for screen readers.
export function setText(node, words) {
  if (node.textContent !== words) node.textContent = words;
}

export function setHidden(node, hidden) {
  if (node.hidden !== hidden) node.hidden = hidden;
}
