// Where the project is: where results are sent, and where tools/results finds the address for its page. It has no public
// place yet, so this is the stand-in that docs/build-systems.md has as well.
export const kAddress = "https://example.com/hashnoise";
