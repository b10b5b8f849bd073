import { element } from '../../viewer/page/dom.js';
import { listenToKeys } from '../../viewer/page/keyboard.js';
import { Theme } from '../../viewer/page/theme.js';
import { Detail } from './detail.js';
import { DetailPicture } from './detail_picture.js';
import { FileSaving } from './file_saving.js';
import { Header } from './header.js';
import { KeysDialog } from './keys_dialog.js';
import { ProposalList } from './list.js';
import { Review, kFilters } from './review.js';
import { ServerSaving } from './server_saving.js';
import { WholePicture } from './whole_picture.js';

const data = JSON.parse(document.getElementById('opal-review').textContent);
const review = new Review(data);
const saving = data.server ? new ServerSaving(data.server, review) : new FileSaving(review);
const theme = new Theme(() => {});
const close = new DetailPicture(review, data.map),
  whole = new WholePicture(review, data.map),
  list = new ProposalList(review),
  detail = new Detail(review, close);

const shortcuts = [
  [['j', 'ArrowDown'], 'next proposal', () => review.move(1)],
  [['k', 'ArrowUp'], 'previous proposal', () => review.move(-1)],
  [['a'], 'accept', () => review.decide('accepted')],
  [['r'], 'refuse', () => review.decide('refused')],
  [['u'], 'undo', () => review.undo()],
  [['s'], 'save', () => saving.save()],
  [['f'], 'next filter', () => review.choose(nextFilter())],
  [['+', '='], 'zoom in', () => close.zoom(1.4)],
  [['-'], 'zoom out', () => close.zoom(1 / 1.4)],
  [['0'], 'show all of the proposal', () => close.fit()],
  [['t'], 'light, dark, as the system', () => theme.next()],
  [['?'], 'these keys', () => help.open()],
];
const help = new KeysDialog(shortcuts);
const header = new Header(review, saving, {
  notes: data.notes,
  isServed: Boolean(data.server),
  theme: () => theme.next(),
  help: () => help.open(),
});

function nextFilter() {
  const names = kFilters.map(([name]) => name);
  return names[(names.indexOf(review.filter) + 1) % names.length];
}

function update() {
  header.update();
  if (review.proposals.length === 0) return;
  list.update();
  detail.update();
  close.show(review.current);
  whole.show(review.current, review.shown());
}

function build() {
  const root = document.getElementById('review');
  root.replaceChildren(header.root, header.notes, help.root);
  if (review.proposals.length === 0)
    return root.append(element('p', { class: 'nothing', text: 'Drives found nothing that is not as the map says.' }));
  const stage = element('div', { class: 'stage' }, close.root, detail.legend, detail.words);
  const side = element('div', { class: 'side' }, whole.root, detail.table);
  root.append(element('main', {}, list.root, stage, side));
}

document.title = `Review of ${data.document.map}`;
build();
review.onChange(update);
review.onChange(() => saving.changed());
listenToKeys(shortcuts, () => help.root.open);
update();
