// Running one named step after another, each with a clock: what every script of this folder is made of.

import { spawn } from "node:child_process";
import { fileURLToPath } from "node:url";

/** The project's folder. */
export const root = fileURLToPath(new URL("..", import.meta.url));

/** A failure that needs a sentence and no stack trace. */
export class Failure extends Error {}

const terminal = process.stdout.isTTY === true;
const seconds = (/** @type {number} */ since) => `${((performance.now() - since) / 1000).toFixed(1)} s`;

/**
 * Runs `work` under a name, and shows the name, a running clock and at the end how long it took.
 *
 * @template T
 * @param {string} name
 * @param {(note: (text: string) => void) => T | Promise<T>} work `note` shows what the step is at; the last note stays.
 * @returns {Promise<T>}
 */
export async function step(name, work) {
  const start = performance.now();
  let detail = "";
  const draw = () => {
    const line = `… ${name}  ${seconds(start)}  ${detail}`;
    if (terminal) process.stdout.write(`\r\x1b[K${line.slice(0, (process.stdout.columns ?? 80) - 1)}`);
  };
  if (!terminal) console.log(`… ${name}`);
  const clock = terminal
    ? setInterval(draw, 100)
    : setInterval(() => console.log(`… ${name}  ${seconds(start)}  ${detail}`), 30_000);
  const end = (/** @type {string} */ mark) => {
    clearInterval(clock);
    console.log(`${terminal ? "\r\x1b[K" : ""}${mark} ${name}  ${seconds(start)}${detail ? `  (${detail})` : ""}`);
  };
  try {
    const result = await work((text) => {
      detail = text;
    });
    end("✔");
    return result;
  } catch (error) {
    detail = "";
    end("✘");
    throw error;
  }
}

/**
 * Runs a program quietly: its output is shown only if it fails. Its latest line goes to `note`.
 *
 * @param {string} program
 * @param {string[]} args
 * @param {{ note?: (text: string) => void, env?: Record<string, string> }} [options]
 * @returns {Promise<string>} what it printed on standard output
 */
export function run(program, args, { note, env } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd: root, env: { ...process.env, ...env }, stdio: ["ignore", "pipe", "pipe"] });
    let printed = "";
    let everything = "";
    const collect = (/** @type {Buffer} */ chunk) => {
      everything += chunk;
      const lines = everything.trimEnd().split("\n");
      note?.(lines[lines.length - 1].trim());
    };
    child.stdout.on("data", (chunk) => {
      printed += chunk;
      collect(chunk);
    });
    child.stderr.on("data", collect);
    child.on("error", (error) => reject(explain(program, error)));
    child.on("close", (code) => {
      note?.("");
      if (code === 0) resolve(printed);
      else reject(new Failure(`${everything.trimEnd()}\n\n"${program} ${args.join(" ")}" failed.`));
    });
  });
}

/**
 * Runs a program whose output is the point: it goes straight to the terminal, between two lines with the step's name.
 *
 * @param {string} name
 * @param {string} program
 * @param {string[]} args
 * @param {Record<string, string>} [env]
 */
export async function show(name, program, args, env = {}) {
  const start = performance.now();
  console.log(`\n… ${name}: ${program} ${args.join(" ")}`);
  const code = await new Promise((resolve, reject) => {
    const child = spawn(program, args, { cwd: root, env: { ...process.env, ...env }, stdio: "inherit" });
    child.on("error", (error) => reject(explain(program, error)));
    child.on("close", resolve);
  });
  console.log(`${code === 0 ? "✔" : "✘"} ${name}  ${seconds(start)}`);
  if (code !== 0) throw new Failure(`"${name}" failed; what it printed is above.`);
}

/** @type {Record<string, string>} */
const howToGet = {
  cargo: "Rust's cargo is missing: install Rust from https://rustup.rs and open a new terminal.",
  rustc: "Rust's compiler is missing: install Rust from https://rustup.rs and open a new terminal.",
  rustup: "rustup is missing: install it from https://rustup.rs and open a new terminal.",
  npm: "npm is missing: install Node 20 or newer from https://nodejs.org (npm comes with it).",
};

/**
 * @param {string} program
 * @param {NodeJS.ErrnoException} error
 */
function explain(program, error) {
  if (error.code !== "ENOENT") return error;
  return new Failure(howToGet[program] ?? `The program "${program}" is missing.`);
}

/**
 * Runs a script's body: a failure prints its sentence and ends the process with status 1.
 *
 * @param {() => Promise<void>} body
 */
export async function main(body) {
  try {
    await body();
  } catch (error) {
    console.error(`\n${error instanceof Failure ? error.message : error instanceof Error ? error.stack : error}`);
    process.exit(1);
  }
}
