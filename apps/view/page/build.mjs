#!/usr/bin/env node
/**
 * Writes the page as one file without data.
 *
 * usage: node build.mjs OUT [MODULES]
 *
 * OUT: a folder; the page is OUT/page.html, and OUT/page-licences.txt has the licences of what it contains. OUT/compare.js
 * is the script of the page of a comparison, which contains no packages.
 * MODULES: the node_modules folder, if it is not beside this file.
 */
import { readFileSync, mkdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
/** What the program that writes a page replaces. Each stands in the page once. */
const PLACEHOLDERS = ['@NILAS_TITLE@', '@NILAS_FACTS@', '@NILAS_BLOCKS@'];

function licences(modules) {
  return ['three', 'uplot'].map((name) => {
    const { version, homepage } = JSON.parse(readFileSync(join(modules, name, 'package.json'), 'utf8'));
    return `${name} ${version}, ${homepage}\n\n${readFileSync(join(modules, name, 'LICENSE'), 'utf8').trim()}\n`;
  }).join('\n----\n\n');
}

/** The scripts of the two pages, and the style sheet of the first. */
async function bundle(modules, licenceText) {
  const esbuild = createRequire(join(modules, 'x.js'))('esbuild');
  const result = await esbuild.build({
    entryPoints: { main: join(here, 'src/main.js'), page: join(here, 'page.css'), compare: join(here, 'src/compare/main.js') },
    bundle: true, format: 'iife', minify: true, write: false,
    outdir: 'out', legalComments: 'inline', charset: 'utf8', target: ['chrome111', 'firefox113', 'safari16.4'], nodePaths: [modules],
    define: { LICENCES: JSON.stringify(licenceText) }, logLevel: 'warning',
  });
  const text = (name) => result.outputFiles.find((file) => file.path.endsWith(name)).text;
  return { script: inPage(text('main.js')), style: `${text('main.css')}\n${text('page.css')}`, compare: inPage(text('compare.js')) };
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
  const { script, style, compare } = await bundle(modules, licenceText);
  let page = readFileSync(join(here, 'index.html'), 'utf8');
  page = fill(page, '@PAGE_STYLE@', style);
  page = fill(page, '@PAGE_SCRIPT@', script);
  for (const placeholder of PLACEHOLDERS) fill(page, placeholder, '');
  mkdirSync(out, { recursive: true });
  writeFileSync(join(out, 'page.html'), page);
  writeFileSync(join(out, 'page-licences.txt'), licenceText);
  writeFileSync(join(out, 'compare.js'), compare);
  console.log(`${join(out, 'page.html')}: ${Math.round(page.length / 1000)} kB`);
}

main().catch((error) => {
  console.error(error.message);
  process.exit(1);
});
