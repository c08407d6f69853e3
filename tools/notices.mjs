// The notices of the crates that the modules are compiled from: their licences ask that they go along.

import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { Failure, root } from "./steps.mjs";

/**
 * @typedef {{ id: string, name: string, version: string, license: string | null, repository: string | null, manifest_path: string,
 *   targets: { kind: string[] }[] }} Crate
 * @typedef {{ id: string, deps: { pkg: string, dep_kinds: { kind: string | null }[] }[] }} Node
 */

/** Where a crate has more licences than one to choose from, this text is enough. */
const CHOICE = /^LICEN[CS]E[-_.]?MIT|^MIT/i;
const LICENCE = /^(LICEN[CS]E|COPYING|NOTICE|UNLICENSE)/i;

/**
 * The text of the notices.
 *
 * @param {string} target what is compiled for
 */
export function notices(target) {
  const args = ["metadata", "--format-version", "1", "--locked", "--filter-platform", target];
  const { packages, resolve } = JSON.parse(execFileSync("cargo", args, { cwd: root, encoding: "utf8", maxBuffer: 1 << 28 }));
  const crates = linked(packages, resolve);
  const parts = crates.map((crate) => [`${crate.name} ${crate.version} (${crate.license})`, crate.repository, "", licence(crate)]);
  const head = "The WebAssembly modules of this package contain code of these crates and of Rust's standard library (MIT or Apache-2.0).";
  return [head, ...parts.map((part) => part.filter((line) => line !== null).join("\n"))].join(`\n\n${"-".repeat(80)}\n\n`) + "\n";
}

/**
 * The crates that are linked into the modules: what the own one needs, and what that needs, but for macros.
 *
 * @param {Crate[]} packages
 * @param {{ root: string, nodes: Node[] }} resolve
 * @returns {Crate[]}
 */
function linked(packages, { root: own, nodes }) {
  const crates = new Map(packages.map((crate) => [crate.id, crate]));
  const needs = new Map(nodes.map((node) => [node.id, node.deps]));
  const isMacro = (/** @type {string} */ id) => crates.get(id)?.targets.some(({ kind }) => kind.includes("proc-macro"));
  const found = new Set([own]);
  for (const id of found) {
    for (const { pkg, dep_kinds } of needs.get(id) ?? []) {
      if (dep_kinds.some(({ kind }) => kind === null) && !isMacro(pkg)) found.add(pkg);
    }
  }
  found.delete(own);
  return [...found].map((id) => /** @type {Crate} */ (crates.get(id))).sort((a, b) => (a.name < b.name ? -1 : 1));
}

/** @param {Crate} crate */
function licence({ name, license, manifest_path }) {
  const folder = dirname(manifest_path);
  const files = readdirSync(folder).filter((file) => LICENCE.test(file) || CHOICE.test(file)).sort();
  const isChoice = license?.includes("MIT") && !license.includes(" AND ");
  const enough = isChoice ? files.find((file) => CHOICE.test(file)) : undefined;
  const texts = (enough ? [enough] : files).map((file) => readFileSync(join(folder, file), "utf8").replaceAll("\r\n", "\n").trim());
  if (texts.length > 0) return texts.join("\n\n");
  if (!license) throw new Failure(`The crate ${name} says nothing of its licence.`);
  return `Under the terms of ${license}.`;
}
