// main.cpp — a scene to spans against the installed libraries: a ball of radius 2 is met from 3 to 7.
#include <cstdio>

#include "csg/eval/canonicalise.h"
#include "csg/eval/evaluate.h"
#include "modeler/io/files.h"
#include "tracer/engine/engine.h"

int main() {
    whittle::Files files;
    whittle::EvaluateInput input;
    input.path = "-";
    input.text = "sphere(2);";
    auto evaluated = whittle::evaluate(input, files);
    const auto canonical = whittle::canonicalise(evaluated->scene, {}, &files, evaluated->diagnostics);
    const auto program = whittle::compile(canonical.solid);
    whittle::Scratch scratch;
    whittle::Spans spans;
    whittle::all_spans(**program, {{0, 0, -5}, {0, 0, 1}}, scratch, spans);
    std::printf("%g %g\n", spans.at(0).in->t, spans.at(0).out->t);
}
