"""ffmpeg plays our films:  python3 film_judge.py RAMURE_CLI FOLDER

A turntable as MP4 and as WebM: its codec, size, rate and number of frames, and its first frame beside the picture that
the same command writes as PNG. A line a film.
"""
import subprocess
import sys
from pathlib import Path

cli, folder = sys.argv[1:]
folder = Path(folder)
folder.mkdir(parents=True, exist_ok=True)
WIDTH, HEIGHT, FRAMES = 321, 200, 6  # an odd side: films have even ones
WIDE = WIDTH + 1
CODECS = {"mp4": "h264", "webm": "vp9"}
MOST_APART = 4.0  # of 255, on average: what the eye's colours lose at half the width


def run(*words, **options):
    return subprocess.run([str(word) for word in words], capture_output=True, check=True, **options).stdout


def pixels(file, crop):
    return run("ffmpeg", "-v", "error", "-i", file, "-frames:v", 1, "-vf", f"format=rgb24,crop={crop}:{HEIGHT}:0:0",
               "-f", "rawvideo", "-pix_fmt", "rgb24", "-")


def turntable(file):
    run(cli, "render", "preset:TinyTree", "--turntable", FRAMES, "--size", f"{WIDTH}x{HEIGHT}", "-o", file)


bad = False
turntable(folder / "turn.png")
picture = pixels(folder / "turn_0000.png", WIDTH)
for ending, codec in CODECS.items():
    film = folder / f"turn.{ending}"
    turntable(film)
    facts = run("ffprobe", "-v", "error", "-count_frames", "-show_entries",
                "stream=codec_name,width,height,r_frame_rate,nb_read_frames", "-of", "csv=p=0", film, text=True).strip()
    frame = pixels(film, WIDTH)
    apart = sum(abs(a - b) for a, b in zip(frame, picture)) / len(picture)
    good = facts == f"{codec},{WIDE},{HEIGHT},24/1,{FRAMES}" and len(frame) == len(picture) and apart < MOST_APART
    bad = bad or not good
    print(f"ffmpeg: {film.name}: {facts}, first frame {apart:.2f} of 255 from the picture{'' if good else ': WRONG'}")
sys.exit(bad)
