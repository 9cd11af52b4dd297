// Data as the program makes it: from MANIFUZZ_PAGE, a page of the corpus that `manifuzz report` wrote. tests/page/run makes it.

import {readFileSync} from 'node:fs';

const start = '<script type="application/json" id="data">';
const page = readFileSync(process.env.MANIFUZZ_PAGE, 'utf8');
const [begin, end] = [page.indexOf(start) + start.length, page.indexOf('</script>', page.indexOf(start))];

/** The page that shows `data` instead. */
export function pageOf(data) {
  return page.slice(0, begin) + JSON.stringify(data).replaceAll('<', '\\u003c') + page.slice(end);
}

/** Every case of the page, afresh. */
export function allCases() {
  return JSON.parse(page.slice(begin, end)).cases;
}

/** Every case of the corpus. */
export function corpusCases() {
  return allCases().filter(({file}) => file.startsWith('corpus/'));
}

/** A page of these parts and nothing else. */
export function reportOf(parts = {}) {
  return {
    format: 'manifuzz/report/1', version: '0.1.0', command: 'manifuzz report corpus run.json --output page.html',
    sources: [{path: 'corpus', kind: 'cases', cases: parts.cases?.length ?? 0}], errors: [],
    fuzz: [], replay: [], bench: [], stress: [], scene: [], cases: [], sequences: [], ...parts,
  };
}

/** What a measuring command wrote, kept beside the tests. */
export function fixture(kind) {
  const path = new URL(`fixtures/${kind}.json`, import.meta.url);
  return {path: `${kind}.json`, result: JSON.parse(readFileSync(path, 'utf8'))};
}
