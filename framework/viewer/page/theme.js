const kKey = 'opal-theme';
const kOrder = ['auto', 'light', 'dark'];
const kDark = window.matchMedia('(prefers-color-scheme: dark)');

/// Light, dark, or as the system says; remembered where the browser allows it.
export class Theme {
  constructor(changed) {
    this.choice = recall();
    this.changed = changed;
    kDark.addEventListener('change', () => this.apply());
    this.apply(false);
  }

  get name() {
    return this.choice === 'auto' ? (kDark.matches ? 'dark' : 'light') : this.choice;
  }

  next() {
    this.choice = kOrder[(kOrder.indexOf(this.choice) + 1) % kOrder.length];
    try {
      localStorage.setItem(kKey, this.choice);
    } catch {
      /* a page from a file may have no storage: the choice lasts as long as the page */
    }
    this.apply();
  }

  apply(tell = true) {
    document.documentElement.dataset.theme = this.name;
    if (tell) this.changed();
  }
}

function recall() {
  try {
    const choice = localStorage.getItem(kKey);
    return kOrder.includes(choice) ? choice : 'auto';
  } catch {
    return 'auto';
  }
}
