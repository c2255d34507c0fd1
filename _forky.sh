bash scripts/setup.sh --dev >/tmp/s.log 2>&1; tail -1 /tmp/s.log
. .venv/ortho-paths.sh; which ccx
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
timeout 300 .venv/bin/python _one_suite.py ortho_structural_suite /tmp/st16f 2>&1 | grep -v "ReferenceShape\|%)\|^[-0-9. ,eE]*$" | head -60
