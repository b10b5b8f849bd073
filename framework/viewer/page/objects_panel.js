import { element, setText } from './dom.js';
import { VirtualList } from './virtual_list.js';
import { shortName } from './words_of.js';

const kRow_px = 26;

/// Everything on the map, by name: the way to the objects for those who do not hover.
export class ObjectsPanel {
  constructor(state, show) {
    this.state = state;
    this.map = null;
    this.list = new VirtualList(
      'objects',
      'Mapped features',
      'listbox',
      'option',
      kRow_px,
      (node, item) => this.fillRow(node, item),
      {
        open: ({ key }) => {
          state.set({ object: key });
          show(key);
        },
      },
    );
    this.search = element('input', {
      type: 'search',
      placeholder: 'Search: name, id or type',
      'aria-label': 'Search the map',
      oninput: () => this.refresh(),
    });
    this.root = element(
      'div',
      { class: 'list-panel objects' },
      element('div', { class: 'list-tools' }, this.search),
      this.list.root,
    );
  }

  update(scene) {
    const map = scene?.recording.map ?? this.map;
    if (map === this.map && this.shown) return;
    this.map = map;
    if (this.root.offsetParent !== null) this.refresh();
  }

  refresh() {
    const query = this.search.value.trim().toLowerCase();
    const items = (this.map?.features ?? []).map((feature, key) => this.itemOf(feature, key));
    this.list.show(items.filter((item) => item.text.toLowerCase().includes(query)));
    this.shown = true;
  }

  itemOf(feature, key) {
    const object = this.map.objects[feature.object];
    const kind = shortName(object?.type ?? feature.type),
      type = feature.perceivable ? kind : `${kind}, unseen`;
    return {
      key,
      id: feature.id,
      name: object?.name ? `${object.name} · ${type}` : type,
      text: `${feature.id} ${object?.name ?? ''} ${object?.id ?? ''} ${type}`,
    };
  }

  fillRow(node, item) {
    if (node.childElementCount === 0) node.append(element('span', { class: 'grow' }), element('span', { class: 'quiet' }));
    setText(node.children[0], item.id);
    setText(node.children[1], item.name);
    node.title = item.text;
    node.setAttribute('aria-selected', String(item.key === this.state.object));
  }
}
