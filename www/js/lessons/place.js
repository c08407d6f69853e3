// A figure's place on the page: its boards, its controls, its reading, and its way to the worker.

/** @typedef {import("./board.js").Board} Board */
/** @typedef {import("../common/courier.js").Courier} Courier */

export class Place {
  #figure;
  #courier;
  #boards = Object.assign(document.createElement("div"), { className: "boards" });
  #controls = Object.assign(document.createElement("div"), { className: "controls" });
  #reading = Object.assign(document.createElement("p"), { className: "reading" });

  /** @param {HTMLElement} figure @param {Courier} courier */
  constructor(figure, courier) {
    this.#figure = figure;
    this.#courier = courier;
    this.#controls.hidden = true;
    this.#reading.setAttribute("role", "status");
    figure.prepend(this.#boards, this.#controls, this.#reading);
    figure.dataset.state = "working";
  }

  /** @param {Board[]} boards side by side */
  put(...boards) {
    this.#boards.append(...boards.map(({ element }) => element));
  }

  /** What is read off the figure. @param {string} words */
  say(words) {
    this.#reading.textContent = words;
  }

  /** A picture that questions may name. @param {import("../common/images.js").Picture} picture */
  know(picture) {
    this.#courier.know(picture);
  }

  /** Asks the worker; `use` gets the answer unless a newer question has taken its place. @param {import("./answers.js").Question} question @param {(answer: any) => void} use */
  ask(question, use) {
    this.#figure.dataset.state = "working";
    this.#courier.ask(this.#figure.id, question).then(
      (answer) => {
        if (answer === null) return;
        use(answer);
        this.#figure.dataset.state = "ready";
      },
      (error) => {
        this.say(error.message);
        this.#figure.dataset.state = "ready";
      },
    );
  }

  /**
   * @param {string} label @param {[value: string, words: string][]} options @param {(value: string) => void} onChange
   */
  choice(label, options, onChange) {
    const select = document.createElement("select");
    select.append(...options.map(([value, words]) => new Option(words, value)));
    select.addEventListener("change", () => onChange(select.value));
    this.#control(label, select);
    return select;
  }

  /**
   * @param {string} label @param {{ min: number, max: number, step: number, value: number }} range @param {(value: number) => void} onInput
   */
  slider(label, { min, max, step, value }, onInput) {
    const input = Object.assign(document.createElement("input"), { type: "range", min: String(min), max: String(max), step: String(step), value: String(value) });
    input.addEventListener("input", () => onInput(input.valueAsNumber));
    this.#control(label, input);
    return input;
  }

  /** @param {string} words @param {() => void} onClick */
  button(words, onClick) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: words });
    button.addEventListener("click", onClick);
    this.#controls.append(button);
    this.#controls.hidden = false;
    return button;
  }

  /** @param {string} label @param {HTMLElement} control */
  #control(label, control) {
    const holder = document.createElement("label");
    holder.append(Object.assign(document.createElement("span"), { textContent: label }), control);
    this.#controls.append(holder);
    this.#controls.hidden = false;
  }
}
