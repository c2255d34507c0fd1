#!/usr/bin/env bash
# The main job from end to end: a freeform roof becomes fabrication files. See usage below.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage() {
  cat <<'TEXT'
usage: bash scripts/demo.sh [OUT_DIR] [--surface FILE.step|stl|obj [--edge L] | --mesh FILE.obj]
                            [--unit mm|cm|m|in|ft]
                            [--height MM] [--thickness MM] [--panel-thickness MM]

Installs what is missing, then turns a design surface into a principal mesh along its lines of
curvature, torsion-free beams, a beam along the border and flat panels, and writes into OUT_DIR
(default: ./out/demo):

  structure.step  every part as a named solid               parts.csv    the parts list
  flat.dxf        their outlines for cutting                report.json  what was reached
  model.FCStd     the model for FreeCAD                     preview.png  a picture of it
  net.obj         the exact net                            nodes.csv    angles at the nodes
  stock.csv       bars to saw beams from                   bevels.csv   sides that are not square
  report.html     verdict, pictures, plots                 net.json     the net and its border
  edge-beam.csv   the border, bend by bend
  aligned.obj, aligned.json                                the net before it was made exact

  --surface    a surface of your own (default: examples/data/demo_roof.step)
  --edge       edges of the net on it, in its unit (default: for about 600 faces)
  --mesh       a quad mesh of your own in place of a surface; it is made exact as it is
  --unit       unit of either (default: as its file says, else mm; of a mesh that says none guessed
               from its edges and said)
  --height     height of the beams (default: 200, or a fifth of the mean edge of small quads)
  --thickness  thickness of the beams (default: 20, or as the height)
  --panel-thickness  thickness of the panels (default: 3, steel sheet, or as the height)
TEXT
}

wrong() { fail "$1; see --help" 2; }

positive() {
  [[ "$2" =~ ^[0-9]*\.?[0-9]+$ && "$2" =~ [1-9] ]] || wrong "$1: expected millimetres above 0, got '$2'"
}

out= source=
options=()
while [ $# -gt 0 ]; do
  case "$1" in
    -h | --help) usage; exit 0 ;;
    --surface | --mesh | --edge | --unit | --height | --thickness | --panel-thickness)
      [ $# -ge 2 ] || wrong "$1 needs a value"
      case "$1" in
        --surface | --mesh)
          if [ ! -r "$2" ] || [ -d "$2" ]; then wrong "$1: no readable file '$2'"; fi
          [ -z "$source" ] || [ "$source" = "$1" ] || wrong "--surface and --mesh: give one of them"
          source=$1
          ;;
        --edge) [ -n "$2" ] || wrong "--edge is empty" ;;
        --unit) [[ "$2" =~ ^(mm|cm|m|in|ft)$ ]] || wrong "--unit: expected mm, cm, m, in or ft, got '$2'" ;;
        *) positive "$1" "$2" ;;
      esac
      options+=("$1" "$2")
      shift 2
      ;;
    -*) wrong "unknown option '$1'" ;;
    *)
      [ -z "$out" ] || wrong "one OUT_DIR is enough, got '$out' and '$1'"
      [ -n "$1" ] || wrong "OUT_DIR is empty"
      out=$1
      shift
      ;;
  esac
done
if [ "$source" = --mesh ] && [[ " ${options[*]} " == *" --edge "* ]]; then
  wrong "--edge: a mesh has its edges already; leave it out"
fi
out=${out:-out/demo}
if ! mkdir -p "$out" 2>/dev/null || [ ! -w "$out" ]; then
  fail "$out: cannot be written; choose a folder that you may write to" 2
fi

bash "$root/scripts/setup.sh"
# shellcheck source=/dev/null
. "$venv/ortho-paths.sh"
PYTHONPATH="$root${PYTHONPATH:+:$PYTHONPATH}" exec "$venv/bin/python" \
  "$root/scripts/demo.py" "$out" ${options[@]+"${options[@]}"}
