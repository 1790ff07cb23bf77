/* What the engine asks of the worker that it runs in. */
mergeInto(LibraryManager.library, {
  /* How far the work has got. */
  web_progress: function (done, all) {
    Module['progress'](done, all);
  },
  /* Files lie in memory, where nothing is to be flushed. */
  syncfs: function () {
    return 0;
  },
});
