"""Native OpenCV on the pictures and maps of benches/peers.mjs, one thread: pip install opencv-python-headless."""

import math
import time

import cv2
import numpy

SIZE, ANGLE = 512, 0.35
CASES = [
    ("shrunk to a third and turned", 0.5, lambda z: 3 * numpy.exp(1j * ANGLE) * z),
    ("enlarged 2.5 times and turned", 0.5, lambda z: 0.4 * numpy.exp(1j * ANGLE) * z),
    ("z²/2, shrunk up to 6 times", 2.0, lambda z: z * z / 2),
]


def picture(size):
    """The picture of benches/lib/pictures.mjs."""
    seeds = numpy.empty(size * size, dtype=numpy.uint32)
    seed = 1
    for k in range(size * size):
        seed = (seed * 1664525 + 1013904223) & 0xFFFFFFFF
        seeds[k] = seed
    noise = ((seeds >> 24) & 15).reshape(size, size).astype(int)
    y, x = numpy.mgrid[0:size, 0:size]
    checker = numpy.where((x >> 5 ^ y >> 5) & 1, 180, 40)
    channels = [checker + noise, x * 240 // size + noise, y * 240 // size + noise, numpy.full((size, size), 255)]
    return numpy.stack(channels, axis=-1).astype(numpy.uint8)


def places(of, width, columns, texture):
    """Where each of columns² pixels of a frame looks in a picture two units wide."""
    step = width / columns
    x = (numpy.arange(columns) + 0.5 - columns / 2) * step
    z = of(x[None, :] - 1j * x[:, None])
    return ((z.real / 2 + 0.5) * texture - 0.5).astype(numpy.float32), ((0.5 - z.imag / 2) * texture - 0.5).astype(numpy.float32)


def milliseconds(work):
    best = math.inf
    for _ in range(8):
        start = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - start)
    return 1000 * best


def main():
    cv2.setNumThreads(1)
    image = picture(2048)
    print(f"## Native OpenCV {cv2.__version__} (Python), one thread: the same pictures, {SIZE}²\n")
    print("| picture | how | time | PSNR |\n|---|---|---|---|")
    for title, width, of in CASES:
        # The mean of 256 samples a pixel, as in benches/lib/quality.mjs.
        truth = numpy.zeros((SIZE, SIZE, 3))
        fine_x, fine_y = places(of, width, 16 * SIZE, 2048)
        fine = image[numpy.clip(numpy.rint(fine_y), 0, 2047).astype(int), numpy.clip(numpy.rint(fine_x), 0, 2047).astype(int), :3]
        truth = fine.reshape(SIZE, 16, SIZE, 16, 3).mean(axis=(1, 3))
        x, y = places(of, width, SIZE, 2048)
        for name, flag in [("remap, bilinear", cv2.INTER_LINEAR), ("remap, bicubic", cv2.INTER_CUBIC), ("remap, Lanczos", cv2.INTER_LANCZOS4)]:
            draw = lambda: cv2.remap(image, x, y, flag)
            found = draw()[..., :3].astype(float)
            error = ((found - truth)[4:-4, 4:-4] ** 2).mean()
            print(f"| {title} | {name} | {milliseconds(draw):.2f} ms | {10 * math.log10(255**2 / error):.1f} dB |")


main()
