
/* What the scripts of all pages use: the page's data, its elements, and new ones. */
const data = JSON.parse(document.getElementById('data').textContent);
const root = document.documentElement;
const at = id => document.getElementById(id);

/* An element with properties and children; text is never read as markup. */
function make(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

const clamp = (value, least, most) => Math.min(Math.max(value, least), most);
