/** A function, a struct or a constant of WGSL, and those that it needs. */
export interface Definition {
  readonly code: string;
  readonly needs: readonly Definition[];
}

/** The text of these definitions and of all that they need, each once. */
export declare function wgsl(...definitions: Definition[]): string;
