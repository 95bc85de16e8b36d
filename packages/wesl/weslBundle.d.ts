export interface WeslBundle {
  name: string;
  edition: string;
  modules: Record<string, string>;
  dependencies?: WeslBundle[];
}
export declare const weslBundle: WeslBundle;
export default weslBundle;
