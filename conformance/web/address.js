// Where the project is, and results are sent; tools/lib/base/tree.py reads it here, too. The project has no public place
// yet, so this is a stand-in. tools/make catalog writes it into pages and packages, and a test compares all files.
export const kAddress = "https://example.com/hashnoise";
