// A visitor's own photos, kept in this browser until they are forgotten; nothing of them leaves the computer.

/** @typedef {{ id: string, title: string, blob: Blob }} Kept */

const STORE = "photos";
/** A browser that does not answer in this time keeps nothing; in milliseconds. */
const PATIENCE = 1000;

/** @type {Promise<IDBDatabase> | undefined} */
let database;

/** @returns {Promise<IDBDatabase>} */
function opened() {
  database ??= new Promise((resolve, reject) => {
    const request = indexedDB.open("conformal-warp", 1);
    request.onupgradeneeded = () => request.result.createObjectStore(STORE, { keyPath: "id" });
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
    setTimeout(() => reject(new Error("The browser's storage does not answer.")), PATIENCE);
  });
  return database;
}

/** One transaction on the store. @template T @param {IDBTransactionMode} mode @param {(store: IDBObjectStore) => IDBRequest<T>} ask @returns {Promise<T>} */
async function inStore(mode, ask) {
  const transaction = (await opened()).transaction(STORE, mode);
  const request = ask(transaction.objectStore(STORE));
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve(request.result);
    transaction.onabort = transaction.onerror = () => reject(transaction.error);
  });
}

/** All that is kept; nothing where the browser keeps nothing, as in some private windows. @returns {Promise<Kept[]>} */
export const keptPhotos = () => inStore("readonly", (store) => store.getAll()).catch(() => []);

/** Keeps a photo, where the browser can. @param {Kept} photo @returns {Promise<boolean>} whether it does */
export const keepPhoto = (photo) => inStore("readwrite", (store) => store.put(photo)).then(() => true, () => false);

/** Forgets all of them. */
export const forgetPhotos = () => inStore("readwrite", (store) => store.clear());
