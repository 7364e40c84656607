// @ts-check
// Parts of tabs that are loaded when a tab is first opened: style sheets and documents.

/** Those that are loaded or on their way. @type {Map<string, Promise<void>>} */
const styled = new Map();

/** Loads a style sheet, in the position among the others that it would have in the page's head. @param {string} address */
export function style(address) {
  const sheet = document.createElement("link");
  const loaded = styled.get(address) ?? new Promise((/** @type {(done: void) => void} */ resolve, reject) => {
    sheet.rel = "stylesheet";
    sheet.href = address;
    sheet.onload = () => resolve();
    sheet.onerror = () => {
      sheet.remove();
      styled.delete(address);
      reject(new Error("its style could not be loaded"));
    };
    const small = document.querySelector('link[href*="small.css"]');
    document.head.insertBefore(sheet, small);
  });
  styled.set(address, loaded);
  return loaded;
}

/** The text of a document, for a tab to hold. @param {URL} address */
export async function text(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`a part of it could not be fetched (status ${response.status})`);
  return response.text();
}
