// The changes of this visit, step by step, so that they can be undone and done again.
import { kSettings, possible } from "./model.js";

const kMostSteps = 200;
const kOneStep = 1000; // milliseconds; what changes the same settings again within them belongs to the same step

// The settings of the whole picture, and its layers as one.
const kUndone = ["layers", ...Object.keys(kSettings).filter((name) => !kSettings[name].layer)];
const text = (part) => (typeof part === "object" ? JSON.stringify(part) : part);
const differing = (one, other) => kUndone.filter((name) => text(one[name]) !== text(other[name]));

// The state with what differs between two others as the second of them has it. All else stays: a picture that plays
// goes on where it is.
const moved = (state, from, to) =>
  possible({ ...state, ...Object.fromEntries(differing(from, to).map((name) => [name, to[name]])) });

export class Steps {
  // `now` gives milliseconds.
  constructor(now = () => performance.now()) {
    this.now = now;
    this.done = []; // each {before, after}: the states around a step
    this.undone = [];
    this.last = undefined; // {key, time} of the last change
  }

  // `key` names which settings are changed. Changes without one are a step each; one that `follows` is of the step before.
  note(before, after, key, follows = false) {
    if (!differing(before, after).length) return;
    const time = this.now();
    const goesOn = key !== undefined && this.last?.key === key && (follows || time - this.last.time < kOneStep);
    this.last = { key, time };
    this.undone = [];
    if (!goesOn) this.done.push({ before });
    const step = this.done.at(-1);
    step.after = after;
    // One slider that is back where it was has changed nothing.
    if (!differing(step.before, after).length) {
      this.done.pop();
      this.last = undefined;
    }
    if (this.done.length > kMostSteps) this.done.shift();
  }

  // The state before the last step; nothing if there is none.
  undo(state) {
    const step = this.done.pop();
    if (!step) return undefined;
    this.last = undefined;
    this.undone.push(step);
    return moved(state, step.after, step.before);
  }

  redo(state) {
    const step = this.undone.pop();
    if (!step) return undefined;
    this.done.push(step);
    return moved(state, step.before, step.after);
  }
}
