// Where the project is, and results are sent; tools/make results reads it here, too. The project has no public place
// yet, so this is the stand-in that docs/guide/build-systems.md has as well.
export const kAddress = "https://example.com/hashnoise";
