// What a browser remembers of a reader; a frame that may remember nothing (a notebook's) forgets it with the page.

function kept(find: () => Storage): Pick<Storage, "getItem" | "setItem" | "removeItem"> {
  try {
    const there = find();
    there.getItem("");
    return there;
  } catch {
    const own = new Map<string, string>();
    return { getItem: (key) => own.get(key) ?? null, setItem: (key, value) => void own.set(key, value), removeItem: (key) => void own.delete(key) };
  }
}

/** From one visit to the next. */
export const remembered = kept(() => localStorage);
/** While this tab is open. */
export const session = kept(() => sessionStorage);
