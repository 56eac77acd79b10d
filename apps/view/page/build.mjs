#!/usr/bin/env node
/**
 * Writes each page as one file without data.
 *
 * usage: node build.mjs OUT [MODULES]
 *
 * OUT: a folder for the pages of PAGES and page-licences.txt, which has the licences of what they contain. OUT/compare.js
 * is the script of the page of a comparison, which contains no packages.
 * MODULES: the node_modules folder, if it is not beside this file.
 */
import { readFileSync, mkdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
/** The pages. `placeholders`: what the program that writes a page replaces; each stands in the page once. */
const PAGES = [
  { out: 'page.html', template: 'index.html', script: 'src/main.js', style: 'page.css',
    placeholders: ['@NILAS_TITLE@', '@NILAS_FACTS@', '@NILAS_BLOCKS@'] },
  { out: 'report.html', template: 'report.html', script: 'src/report/main.js', style: 'report.css',
    placeholders: ['@NILAS_TITLE@', '@NILAS_BODY@', '@NILAS_DATA@'] },
];

function licences(modules) {
  return ['three', 'uplot'].map((name) => {
    const { version, homepage } = JSON.parse(readFileSync(join(modules, name, 'package.json'), 'utf8'));
    return `${name} ${version}, ${homepage}\n\n${readFileSync(join(modules, name, 'LICENSE'), 'utf8').trim()}\n`;
  }).join('\n----\n\n');
}

/** The script and the style sheet of a page; no style sheet where none is given. */
async function bundle({ script, style }, modules, licenceText) {
  const esbuild = createRequire(join(modules, 'x.js'))('esbuild');
  const sheet = style ? { style: join(here, style) } : {};
  const result = await esbuild.build({
    entryPoints: { script: join(here, script), ...sheet }, bundle: true, format: 'iife', minify: true, write: false,
    outdir: 'out', legalComments: 'inline', charset: 'utf8', target: ['chrome111', 'firefox113', 'safari16.4'], nodePaths: [modules],
    define: { LICENCES: JSON.stringify(licenceText) }, logLevel: 'warning',
  });
  const text = (name) => result.outputFiles.find((file) => file.path.endsWith(name)).text;
  const css = (name) => result.outputFiles.find((file) => file.path.endsWith(name))?.text ?? '';
  return { script: inPage(text('script.js')), style: `${css('script.css')}\n${css('style.css')}` };
}

/** A script that stands within a page. */
function inPage(script) { return script.replaceAll('</script', '<\\/script'); }

/** Replaces one placeholder of the template; functions keep `$` in the text as it is. */
function fill(template, placeholder, text) {
  const parts = template.split(placeholder);
  if (parts.length !== 2) throw new Error(`${placeholder} stands ${parts.length - 1} times in the page, not once.`);
  return parts.join(text);
}

async function main() {
  const [out, modulesArgument] = process.argv.slice(2);
  if (!out) throw new Error('usage: node build.mjs OUT [MODULES]');
  const modules = resolve(modulesArgument ?? join(here, 'node_modules'));
  const licenceText = licences(modules);
  mkdirSync(out, { recursive: true });
  for (const entry of PAGES) {
    const { script, style } = await bundle(entry, modules, licenceText);
    let page = readFileSync(join(here, entry.template), 'utf8');
    page = fill(page, '@PAGE_STYLE@', style);
    page = fill(page, '@PAGE_SCRIPT@', script);
    for (const placeholder of entry.placeholders) fill(page, placeholder, '');
    writeFileSync(join(out, entry.out), page);
    console.log(`${join(out, entry.out)}: ${Math.round(page.length / 1000)} kB`);
  }
  writeFileSync(join(out, 'page-licences.txt'), licenceText);
  const { script } = await bundle({ script: 'src/compare/main.js' }, modules, licenceText);
  writeFileSync(join(out, 'compare.js'), script);
}

main().catch((error) => {
  console.error(error.message);
  process.exit(1);
});
