/// Tells the program every decision as it is made; one message at a time, so that the last one counts.
export class ServerSaving {
  constructor(server, review) {
    this.server = server;
    this.review = review;
    this.words = `Decisions are kept in ${server.decisions}.`;
    this.failed = 0; ///< how many decisions the last try left unsaved
    this.busy = false;
    window.addEventListener('beforeunload', (event) => this.state !== 'saved' && event.preventDefault());
  }

  get state() {
    return this.failed > 0 ? 'failed' : this.busy || this.review.unsaved.size > 0 ? 'waiting' : 'saved';
  }

  changed() {
    const { size } = this.review.unsaved;
    if (size > 0 && size !== this.failed) this.save();
  }

  async save() {
    if (this.busy) return;
    this.busy = true;
    this.words = 'Saving …';
    const { review } = this,
      sent = [...review.unsaved];
    review.unsaved.clear();
    try {
      const told = await this.post(review.documentOf(sent.map((number) => review.proposals[number])));
      review.adopt(told.answers);
      this.failed = 0;
      this.words = `${told.saved}. Written: ${this.server.decisions}, ${this.server.overlay}`;
    } catch (error) {
      for (const number of sent) review.unsaved.add(number);
      this.failed = review.unsaved.size;
      this.words = `Not saved: ${error.message} Nothing is lost while this page is open; save it as a file to be sure.`;
    }
    this.busy = false;
    review.tell(review.message);
  }

  async post(document) {
    const response = await fetch('decisions', {
      method: 'POST',
      headers: { 'Content-Type': 'application/json', 'X-Opal-Token': this.server.token },
      body: JSON.stringify(document),
    }).catch(() => {
      throw new Error('the program does not answer. Has it ended?');
    });
    if (!response.ok) throw new Error((await response.text()).trim());
    return response.json();
  }
}
