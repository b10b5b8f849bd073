import { element } from './dom.js';
import { pairsAt } from './hypothesis_log.js';
import { fixed, localName, poseWords, probabilityWords, seconds, shortName } from './words_of.js';

const kMostPairs = 60;

/// Everything about the selected hypothesis: pose, probability, scores, associations with names; for one that is over, why.
export class DetailsPanel {
  constructor(state, seek) {
    this.state = state;
    this.seek = seek;
    this.body = element('div', {
      class: 'details-body',
      tabindex: '0',
      role: 'region',
      'aria-label': 'Details of the selected hypothesis',
    });
    this.title = element('h2', { text: 'Selected' });
    this.root = element(
      'section',
      { class: 'details', 'aria-label': 'Selected hypothesis' },
      element(
        'header',
        {},
        this.title,
        element('button', {
          type: 'button',
          class: 'tool',
          text: 'Close',
          title: 'Select none (Escape)',
          onclick: () => state.set({ selected: -1 }),
        }),
      ),
      this.body,
    );
    this.shownFor = '';
  }

  update(scene) {
    const picked = scene?.picked ?? null;
    this.root.hidden = this.state.selected < 0;
    if (this.root.hidden) return;
    const shownFor = scene ? `${scene.recording.name} ${scene.frame} ${this.state.selected} ${this.state.run}` : '';
    if (shownFor === this.shownFor) return;
    this.shownFor = shownFor;
    this.title.textContent = `Hypothesis #${this.state.selected}`;
    const scroll = this.body.scrollTop;
    this.body.replaceChildren(...(picked ? this.describe(scene, picked) : [this.absent(scene)]));
    this.body.scrollTop = scroll;
  }

  absent(scene) {
    const known = scene?.recording.hypotheses.byId.get(this.state.selected);
    return element('p', { class: 'quiet', text: known ? 'Not spawned yet at this moment.' : 'There is no such hypothesis.' });
  }

  describe(scene, hypothesis) {
    const { recording, frame } = scene,
      over = hypothesis.endFrame <= frame;
    const parts = [this.facts(scene, hypothesis, over)];
    if (over) parts.push(...this.end(recording, hypothesis));
    else if (hypothesis.id === scene.best) parts.push(...findingsList('Findings', recording.findingsAt(frame), recording.map));
    const scores = over ? hypothesis.end?.scores : scoresAt(recording, frame, hypothesis.id);
    parts.push(...scoreTable(scores));
    parts.push(...this.associations(scene, hypothesis, over));
    parts.push(...this.history(recording, hypothesis, frame));
    return parts;
  }

  facts({ recording, frame }, hypothesis, over) {
    const { rows } = recording,
      row = rows.find(frame, hypothesis.id),
      at = (f) => recording.time.values[f];
    const facts = [['Pose', poseWords(recording.poseAt(frame, hypothesis.id))]];
    if (row >= 0)
      facts.push(
        ['Probability', probabilityWords(rows.probability.values[row])],
        ['Log-likelihood', `${fixed(rows.nat.values[row], 2)} nat`],
      );
    if (over && hypothesis.end)
      facts.push(
        ['Log-likelihood', `${fixed(hypothesis.end.nat, 2)} nat`],
        ['Last scan', `${fixed(hypothesis.end.scan_nat, 2)} nat`],
      );
    const origin = hypothesis.parent >= 0 ? `branch of #${hypothesis.parent}` : shortName(hypothesis.origin);
    facts.push(['Spawned', this.moment(at(hypothesis.spawnedFrame), hypothesis.spawnedFrame, origin && `, ${origin}`)]);
    if (over) facts.push(['Ended', this.moment(at(hypothesis.endFrame), hypothesis.endFrame)]);
    const list = element('dl', { class: 'facts' });
    for (const [name, value] of facts) {
      const content = element('dd');
      content.append(value);
      list.append(element('dt', { text: name }), content);
    }
    return list;
  }

  /// A time that leads to its moment.
  moment(time, frame, more = '') {
    const span = element('span');
    span.append(
      element('button', {
        type: 'button',
        class: 'link',
        text: seconds(time),
        title: 'Go to this moment',
        onclick: () => this.seek(frame),
      }),
      more,
    );
    return span;
  }

  end(recording, { end }) {
    if (!end) return [element('p', { class: 'reason', text: 'Ended with its time line.' })];
    const parts = [element('p', { class: 'reason', text: end.reason })];
    if (end.mergedInto >= 0)
      parts.push(
        element(
          'p',
          {},
          'At the same place as ',
          element('button', {
            type: 'button',
            class: 'link',
            text: `#${end.mergedInto}`,
            onclick: () => this.state.set({ selected: end.mergedInto }),
          }),
        ),
      );
    return [...parts, ...findingsList('Findings', end.findings, recording.map)];
  }

  associations({ recording, frame }, hypothesis, over) {
    const pairs = pairsAt(hypothesis, over ? hypothesis.endFrame : frame);
    const parts = [element('h3', { text: `Associations (${pairs.length})` })];
    const list = element('ul', { class: 'pairs' });
    for (const [local, mapped] of pairs.slice(0, kMostPairs)) list.append(this.pair(recording, local, mapped));
    if (pairs.length > kMostPairs) list.append(element('li', { class: 'quiet', text: `and ${pairs.length - kMostPairs} more` }));
    parts.push(list);
    return parts;
  }

  pair(recording, local, mapped) {
    const name = recording.map.nameOf(mapped);
    const target =
      mapped < 0
        ? element('span', { class: 'quiet', text: name })
        : element('button', {
            type: 'button',
            class: 'link',
            text: name,
            title: 'Show on the map',
            onclick: () => this.state.set({ object: mapped }),
          });
    return element('li', {}, element('span', { class: 'number', text: localName(local) }), ' → ', target);
  }

  history(recording, { nodes, children }, frame) {
    const past = nodes
      .filter((node) => node.frame <= frame && node.kind !== 'grown')
      .slice(-6)
      .reverse();
    const branches = children.filter((child) => child.spawnedFrame <= frame);
    const parts = [];
    if (past.length > 0) {
      const entries = past.map((node) =>
        element('li', {
          text: `${seconds(recording.time.values[node.frame])}: ${node.kind === 'tried' ? 'tried' : 'dropped'} ${node.pairs.map(([l, m]) => `${l} → ${recording.map.nameOf(m)}`).join(', ')}: ${node.reason}`,
        }),
      );
      parts.push(element('h3', { text: 'What did not hold' }), element('ul', {}, ...entries));
    }
    if (branches.length > 0)
      parts.push(
        element('h3', { text: 'Branches' }),
        element('p', {
          text: branches
            .slice(0, 20)
            .map(({ id }) => `#${id}`)
            .join(' '),
        }),
      );
    return parts;
  }
}

function scoresAt(recording, frame, id) {
  return recording.detail(frame).scores?.find(([of]) => of === id)?.[2] ?? null;
}

/// Scores by scorer and term.
function scoreTable(scores) {
  if (!scores || typeof scores !== 'object' || Object.keys(scores).length === 0) return [];
  const rows = [];
  for (const [scorer, terms] of Object.entries(scores)) {
    const entries = terms && typeof terms === 'object' ? Object.entries(terms) : [['', terms]];
    entries.forEach(([term, value], k) =>
      rows.push(
        element(
          'tr',
          {},
          element('td', { text: k === 0 ? shortName(scorer) : '' }),
          element('td', { text: term }),
          element('td', { class: 'number', text: typeof value === 'number' ? fixed(value, 3) : '–' }),
        ),
      ),
    );
  }
  const head = element(
    'thead',
    {},
    element('tr', {}, ...['Scorer', 'Term', 'Value'].map((text) => element('th', { scope: 'col', text }))),
  );
  return [element('h3', { text: 'Scores' }), element('table', { class: 'scores' }, head, element('tbody', {}, ...rows))];
}

function findingsList(title, findings, map) {
  if (findings.length === 0) return [];
  const entries = findings.map(({ scorer, words, feature }) =>
    element(
      'li',
      {},
      `${words}`,
      element('span', { class: 'quiet', text: ` · ${shortName(scorer)}${feature >= 0 ? `, ${map.nameOf(feature)}` : ''}` }),
    ),
  );
  return [element('h3', { text: title }), element('ol', { class: 'findings' }, ...entries)];
}
