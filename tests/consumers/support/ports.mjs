// Servers that projects start.

import { createServer } from "node:net";

/** @returns {Promise<number>} */
export function freePort() {
  return new Promise((resolve, reject) => {
    const server = createServer().on("error", reject);
    server.listen(0, "127.0.0.1", () => {
      const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
      server.close(() => resolve(port));
    });
  });
}

/** The first answer of a server that is starting. @param {string} url */
export async function answer(url) {
  for (let wait = 0; ; wait++) {
    try {
      return await fetch(url);
    } catch (error) {
      if (wait === 100) throw error;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }
}
