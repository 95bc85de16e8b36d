// Where the project is, and results are sent; tools/lib/base/tree.py reads it here, too. The project has no public place
// yet, so this is a stand-in. A test compares it with the addresses in pages.
export const kAddress = "https://example.com/hashnoise";
