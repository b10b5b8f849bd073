/// Keeps decisions in the browser until they are saved as a file, for a page without a server.
export class FileSaving {
  constructor(review) {
    this.review = review;
    const { map, map_digest, evidence_digest } = review.document;
    this.key = `opal-review ${map} ${map_digest} ${evidence_digest}`;
    this.recall();
  }

  get state() {
    return this.review.unsaved.size > 0 ? 'waiting' : 'saved';
  }

  get words() {
    const { size } = this.review.unsaved;
    if (size > 0) return `${size} not in a file yet: save them.`;
    return this.saved
      ? `Saved as ${this.saved}. Make the overlay: opal map review ... --decisions ${this.saved} -o OVERLAY.jsonld`
      : '';
  }

  changed() {
    try {
      localStorage.setItem(
        this.key,
        JSON.stringify(this.review.proposals.map(({ answer, by, at, note }) => ({ answer, by, at, note }))),
      );
    } catch {
      /* a page from a file may have no storage: decisions last as long as the page */
    }
  }

  /// What was said on this page before; a decision that came with the page counts unless it was changed later.
  recall() {
    let kept;
    try {
      kept = JSON.parse(localStorage.getItem(this.key));
    } catch {
      return;
    }
    if (!Array.isArray(kept) || kept.length !== this.review.proposals.length) return;
    kept.forEach(({ answer, by, at, note }, number) => {
      const proposal = this.review.proposals[number];
      if (answer === 'undecided' || !(at > proposal.at)) return;
      Object.assign(proposal, { answer, by, at, note });
      this.review.unsaved.add(number);
    });
    this.review.toFirstUndecided();
  }

  save() {
    this.saved = saveAsFile(this.review);
    this.review.unsaved.clear();
    this.review.tell();
  }
}

/// Downloads the document of all decisions; returns the name of the file.
export function saveAsFile(review) {
  const name = `${review.document.map.replace(/[^\w.-]+/g, '_')}.decisions.json`;
  const address = URL.createObjectURL(
    new Blob([`${JSON.stringify(review.wholeDocument, null, 1)}\n`], { type: 'application/json' }),
  );
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
  return name;
}
