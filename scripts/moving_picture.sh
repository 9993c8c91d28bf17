#!/usr/bin/env bash
# moving_picture.sh: makes docs/images/object_retrieval.gif, the picture of the README, from a run, with a frame every five ticks.
# Needs a sourced devel space and ffmpeg. Takes a minute.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
camera='<opengl_render id="film"><window_size>640, 440</window_size><field_of_view>60</field_of_view>
<camera_view_XYZ_0>2.5, -2.9, 4.2</camera_view_XYZ_0><camera_view_HPR_0>90, -35, 0</camera_view_HPR_0>
<write_frames>true</write_frames><every>5</every><frame_directory>film</frame_directory></opengl_render></visualisations>'
experiment=$(< "$root/src/swarmanoid_experiments/experiments/object_retrieval.xml")
printf '%s\n' "${experiment/<\/visualisations>/"$camera"}" > "$work/film.xml"
cd "$work"
swarmanoid run film.xml --quiet
ffmpeg -loglevel error -y -framerate 12 -i film/frame_%06d.png -vf "scale=560:-1:flags=lanczos,split[a][b];\
[a]palettegen=max_colors=160[p];[b][p]paletteuse=dither=none:diff_mode=rectangle" "$root/docs/images/object_retrieval.gif"
