// The unit that the precompiled header belongs to.
