// A visitor's own picture: chosen, dropped or pasted.

/** @param {HTMLInputElement} input @param {HTMLElement} target where files may be dropped @param {(file: File) => void} open */
export function acceptFiles(input, target, open) {
  /** @param {FileList | undefined} files */
  const take = (files) => {
    const file = [...(files ?? [])].find(({ type }) => type.startsWith("image/")) ?? files?.[0];
    if (file) open(file);
  };
  input.addEventListener("change", () => {
    take(input.files ?? undefined);
    input.value = "";
  });
  window.addEventListener("dragover", (event) => {
    event.preventDefault();
    target.classList.add("dropping");
  });
  window.addEventListener("dragleave", (event) => {
    if (event.relatedTarget === null) target.classList.remove("dropping");
  });
  window.addEventListener("drop", (event) => {
    event.preventDefault();
    target.classList.remove("dropping");
    take(event.dataTransfer?.files);
  });
  window.addEventListener("paste", (event) => take(event.clipboardData?.files));
}
