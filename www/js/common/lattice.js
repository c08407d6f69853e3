// A lattice of coloured cells between dark lines: each place is known by its colour.

const CELLS = 8;

/** @param {CanvasRenderingContext2D} context @param {[width: number, height: number]} size */
export function drawLattice(context, [width, height]) {
  const [across, down] = [width / CELLS, height / CELLS];
  for (let i = 0; i < CELLS; i++) {
    for (let j = 0; j < CELLS; j++) {
      const turns = Math.atan2(CELLS / 2 - j - 0.5, i + 0.5 - CELLS / 2) / (2 * Math.PI);
      const light = (i + j) % 2 ? 0.86 : 0.93;
      context.fillStyle = `oklch(${light} 0.09 ${360 * turns})`;
      context.fillRect(i * across, j * down, across, down);
    }
  }
  context.strokeStyle = "#27304f";
  for (let k = 0; k <= CELLS; k++) {
    context.lineWidth = Math.min(across, down) / (k === CELLS / 2 ? 9 : 18);
    context.stroke(new Path2D(`M${k * across} 0V${height}M0 ${k * down}H${width}`));
  }
}
