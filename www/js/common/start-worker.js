// Workers of the page.

import { WORKER } from "./colours.js";

/** A worker: what it says is received, and why it is of no use any more. @param {URL} script @param {(data: any) => void} receive @param {(why: string) => void} fail */
export function startWorker(script, receive, fail) {
  const worker = new Worker(script, WORKER);
  worker.onmessage = ({ data }) => receive(data);
  worker.onerror = (event) => {
    event.preventDefault();
    fail(event.message || "its script could not be loaded");
  };
  return worker;
}
