// The photos that come with the page.

/** @typedef {{ title: string, file: string, size: [width: number, height: number] }} Photo */

/** @type {Map<string, Photo>} */
export const photos = new Map([
  ["astronaut", { title: "Astronaut", file: "astronaut.jpg", size: [512, 512] }],
  ["chelsea", { title: "Cat", file: "chelsea.jpg", size: [451, 300] }],
  ["coffee", { title: "Coffee", file: "coffee.jpg", size: [600, 400] }],
  ["retina", { title: "Retina", file: "retina.jpg", size: [1411, 1411] }],
]);
