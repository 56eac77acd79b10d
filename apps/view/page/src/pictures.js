/** Pictures that a program takes of the page: it then has nothing that only a user in front of it needs. */

/** Two pictures of the browser later, all that was drawn is on the screen. */
const onScreen = () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));

/**
 * Sets the page up for pictures.
 * @param {import('./app.js').App} app
 * @param {string} words as they stand in the address, for example `t=12.3&view=top`
 * @param {boolean} isPlain leaves out the bar above and the legend
 * @returns {Promise<string[]>} what is wrong with the words, a sentence each
 */
export async function compose(app, words, isPlain) {
  document.body.classList.add('picture');
  document.body.classList.toggle('plain', isPlain);
  for (const name of ['panel', 'graphs']) app.options.set(name, false);
  app.options.set('ui', !isPlain);
  // The camera's view depends on the shape of the picture.
  app.stage.resize();
  const faults = await app.applyWords(words);
  if (app.options.get('graphs')) app.graphs.refreshNow();
  // What the page lays out anew for its new size is done then.
  await onScreen();
  return faults;
}

/** Shows a time and resolves when it is on the screen. `between`: bodies are on their way between two frames. */
export async function shoot(app, time, between) {
  await app.player.seek(time, { between });
  app.stage.draw();
  app.stage.finish();
  await onScreen();
}
