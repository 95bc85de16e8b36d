// Where the project is, and results are sent; tools/lib/base/tree.py reads it here, too. It is empty while the project has
// no public place: then no page and no package has a link to it. tools/make catalog writes it into both, and a test compares
// all files.
export const kAddress = "";
