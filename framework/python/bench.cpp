#include "python/bench.hpp"

#include "benchmark/runs/answer.hpp"
#include "evaluation/place_verdict.hpp"
#include "python/bindings.hpp"
#include "python/plugins.hpp"
#include "python/values/json.hpp"
#include "session/overlays.hpp"
#include "session/shipped_files.hpp"

#include <pybind11/stl.h>

#include <filesystem>
#include <variant>

namespace opal::python {

namespace py = pybind11;

namespace {

std::optional<GroundTruth> truth_of(const benchmark::BenchPlace& place) {
  const std::string file = place.site.prefix + ".gt.csv";
  if (!std::filesystem::exists(file)) return std::nullopt;
  return GroundTruth::read(file);
}

BenchResult run_place(const benchmark::BenchPlace& place) {
  Localizer localizer(build_parts(place.deployment, *registry(), place.site.map));
  BenchResult result{place.site.name, place.queries, {}, truth_of(place), {}};
  Interruptible observer;
  for (const Query& query : place.queries)
    result.run.append(benchmark::run_query(localizer, place, query, {std::ref(observer), {}, {}}));
  result.plugin_failures = localizer.plugin_failures();
  return result;
}

BenchResult bench(const std::string& prefix, const std::variant<Deployment, std::string>& config,
                  const std::string& maps, const std::vector<std::string>& overlays) {
  const py::gil_scoped_release others_run;
  const auto* name = std::get_if<std::string>(&config);
  const Deployment deployment = name != nullptr ? read_deployment(session::config_file(*name)) : std::get<0>(config);
  const PluginRegistry plugins = trusted_by(deployment, *registry());
  benchmark::BenchSite site = benchmark::load_sites(plugins, {prefix}, {maps, std::nullopt}).front();
  std::vector<std::string> all = deployment.overlays;
  all.insert(all.end(), overlays.begin(), overlays.end());
  site.map = session::with_overlays(site.map, all);
  return run_place(benchmark::read_bench_place(plugins, site, deployment));
}

py::object number_or_none(const std::optional<double>& number) {
  if (!number) return py::none();
  return py::float_(*number);
}

/// A row per query: what became of it.
py::dict query_columns(const BenchResult& self) {
  using namespace py::literals;
  py::list ids, success, after_m, localized_m, false_rows, rows;
  for (const Query& query : self.queries) {
    std::vector<ResultRow> of_query;
    for (const ResultRow& row : self.run.rows)
      if (row.query == query.id) of_query.push_back(row);
    const QueryVerdict verdict = self.truth ? judge_query(of_query, query, *self.truth) : QueryVerdict();
    ids.append(query.id);
    rows.append(of_query.size());
    success.append(self.truth ? py::object(py::bool_(verdict.success)) : py::none());
    after_m.append(number_or_none(verdict.right_after_m));
    localized_m.append(number_or_none(verdict.localized_after_m));
    false_rows.append(self.truth ? py::object(py::int_(verdict.false_rows)) : py::none());
  }
  return py::dict("query_id"_a = ids, "rows"_a = rows, "success"_a = success, "right_after_m"_a = after_m,
                  "localized_after_m"_a = localized_m, "false_rows"_a = false_rows);
}

py::object verdict_of(const BenchResult& self) {
  if (!self.truth) return py::none();
  return to_python(to_json(judge_place(self.run.rows, self.queries, *self.truth)));
}

std::string words_of(const BenchResult& self) {
  const std::string verdict = self.truth ? summary_of(judge_place(self.run.rows, self.queries, *self.truth))
                                         : "not judged: there is no recorded truth\n";
  return verdict + benchmark::skipped_text(self.plugin_failures);
}

}  // namespace

void bind_bench(py::module_& module) {
  py::class_<BenchResult>(module, "Bench", "What the queries of a recorded place have come to.")
      .def_readonly("name", &BenchResult::name)
      .def_readonly("run", &BenchResult::run, "All queries, one after the other.")
      .def("columns", &query_columns,
           "A row per query: query_id, rows, success, right_after_m, localized_after_m, false_rows; None where nothing "
           "is known.")
      .def(
          "frame", [](const BenchResult& self) { return data_frame(query_columns(self)); },
          "The same as a pandas.DataFrame; needs pandas.")
      .def_property_readonly("verdict", &verdict_of, "As in summary.json of `opal bench`; None without recorded truth.")
      .def_property_readonly("summary", &words_of,
                             "As `opal bench` prints it, with a line for each plugin that failed.")
      .def_readonly("plugin_failures", &BenchResult::plugin_failures,
                    "Calls into plugins that threw and were skipped, by type name.")
      .def("__repr__", [](const BenchResult& self) {
        return "<opal.Bench " + self.name + ": " + std::to_string(self.queries.size()) + " queries>";
      });
  module.def("bench", &bench, py::arg("prefix"), py::arg("config") = "default", py::arg("maps") = "",
             py::arg("overlays") = std::vector<std::string>(),
             "Runs all queries of a recorded place, as `opal bench PREFIX` does.\n\n"
             "prefix: PREFIX.map.yaml or .jsonld, PREFIX.info.json, PREFIX.queries.json and PREFIX.log.gz are read.\n"
             "config: an opal.Deployment, or the name of one. maps: a folder with another map of the place.\n"
             "Raises opal.Error.");
}

}  // namespace opal::python
