// What this package throws: an Error with a stable code, in words for people.

/**
 * @param {string} code
 * @param {string} message
 * @param {Record<string, unknown>} [details] what else the error carries
 */
export function failure(code, message, details) {
  return Object.assign(new Error(message), { code }, details);
}
