/**
 * Lets shaders of three.js write #include <hashnoise/fbm2d>, for every file of the library. Calling it again changes
 * nothing.
 */
export declare function registerChunks(): void;
