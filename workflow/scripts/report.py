"""The report: one HTML page with every figure, caption and table in it."""

import base64
import datetime
import re
from pathlib import Path

import jinja2
import pandas
import yaml
from markupsafe import Markup

from readable import duration, quantity
from reporting import describe, logged, read_json, write_text
from verdicts import FAILS, HOLDS, UNKNOWN

PAPER_PARTICLES = 100_000
PAPER = (
    "Y. He, A. Hassanpour, A. E. Bayly, Linking particle properties to layer characteristics: Discrete element modelling "
    "of cohesive fine powder spreading in additive manufacturing, Additive Manufacturing 36 (2020) 101685"
)
# Units of the derived numbers, by the first or the last part of their names.
UNITS = {
    "mass": "kg", "inertia": "kg m2", "weight": "N", "diameter": "m", "effective_modulus": "Pa",
    "effective_shear_modulus": "Pa", "hamaker": "J", "pull_off_force": "N", "inertial_length": "d_p",
    "reference_speed": "m/s", "time_step": "s", "limit": "s", "time": "s", "smallest": "m", "largest": "m", "mean": "m",
    "sauter": "m", "median_by_number": "m", "median_by_mass": "m",
}  # fmt: skip


def listing(values):
    """Numbers or names, separated by commas."""
    return ", ".join(f"{value:g}" if isinstance(value, (int, float)) else str(value) for value in values)


def cell(value):
    """A table cell as text: four significant digits, nothing for a missing value."""
    if isinstance(value, float):
        return "" if pandas.isna(value) else f"{value:.4g}"
    try:
        return (
            cell(float(value))
            if isinstance(value, str) and re.fullmatch(r"[-+0-9.eE]*[.eE][-+0-9.eE]*", value)
            else str(value)
        )
    except ValueError:
        return str(value)


def html_table(table):
    """A table as HTML; numbers are set right."""
    head = "".join(f"<th>{Markup.escape(name)}</th>" for name in table.columns)
    rows = []
    for values in table.itertuples(index=False):
        cells = []
        for value in values:
            number = isinstance(value, (int, float))
            cells.append(f'<td{" class=number" if number else ""}>{Markup.escape(cell(value))}</td>')
        rows.append(f"<tr>{''.join(cells)}</tr>")
    return Markup(f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>")


def figure_number(name):
    """fig05_layer_maps belongs to the paper's figure 5."""
    return str(int(re.match(r"fig(\d+)", name).group(1)))


def statements_of(comparison, figure):
    """The rows of the comparison that belong to a figure or section."""
    if figure.isdigit():
        return comparison[comparison["figure"].str.extract(r"^(\d+)")[0] == figure]
    return comparison[comparison["figure"] == figure]


def figure_entry(name, captions, bitmap, sources, comparison):
    """What the template needs of one figure."""
    drawn = read_json(sources)
    mine = statements_of(comparison, figure_number(name))
    first = name != "fig05_rendered_layer"
    return {
        "name": name,
        "title": captions[name]["title"],
        "caption": captions[name]["caption"],
        "image": base64.b64encode(Path(bitmap).read_bytes()).decode(),
        "bonds": listing(drawn["bond_numbers"]),
        "ratios": listing(drawn["stiffness_ratios"]),
        "seeds": listing(drawn["seeds"]),
        "versions": listing(drawn["versions"]),
        "files": listing(drawn["files"]),
        "note": drawn["note"],
        "statements": html_table(mine) if first and len(mine) else "",
    }


def derived_rows(table):
    """Derived numbers with units that a person reads; what is no number stays as it is."""

    def text(name, value):
        first, last = name.split(".")[0], name.split(".")[-1]
        unit = UNITS.get(last if first in ("time_step_limits", "stages", "sizes") else first)
        try:
            return quantity(float(value), unit) if unit and value != "" else value
        except ValueError:
            return value

    rows = [[name, *(text(name, value) for value in values)] for name, *values in table.itertuples(index=False)]
    return pandas.DataFrame(rows, columns=table.columns)


def runtime_rows(table):
    """Run times in hours, minutes and seconds."""
    return pandas.DataFrame(
        {
            "Bo": table["bond_number"],
            "stiffness ratio": table["stiffness_ratio"],
            "seed": table["seed"],
            "stage": table["stage"],
            "particles": table["particles"],
            "steps": [f"{steps:,}" for steps in table["steps"]],
            "time step": [quantity(step, "s") for step in table["time_step_s"]],
            "wall time": [duration(seconds) for seconds in table["wall_seconds"]],
            "particle-steps per second": [quantity(rate, "", 3) or "0" for rate in table["particle_steps_per_second"]],
            "threads": table["threads"],
        }
    )


def layer_rows(metrics):
    """What was analysed of each layer."""
    return pandas.DataFrame(
        {
            "Bo": metrics["bond_number"],
            "stiffness ratio": metrics["stiffness_ratio"],
            "seed": metrics["seed"],
            "length analysed [d_p]": metrics["region_length_dp"],
            "particles in it": metrics["particles"].astype(int),
            "flowed back under the blade [d_p]": [round(way, 1) for way in metrics["flowed_back_dp"]],
        }
    )


def energy_rows(table):
    """Shares of the energy lost while spreading, and the work of the blade."""
    ways = ("collisions", "sliding", "rolling")
    shares = {f"{way} [%]": [f"{100 * share:.1f}" for share in table[f"loss_{way}"]] for way in ways}
    return pandas.DataFrame(
        {
            "Bo": table["bond_number"],
            "stiffness ratio": table["stiffness_ratio"],
            "seed": table["seed"],
            **shares,
            "work of the blade": [quantity(work, "J") for work in table["blade_work_J"]],
        }
    )


def verdict_counts(comparison):
    """How many statements there are of each verdict, and those that do not hold."""
    found = comparison["verdict"].value_counts()
    counts = {verdict: int(found.get(verdict, 0)) for verdict in (HOLDS, FAILS, UNKNOWN)}
    return {"all": len(comparison), "counts": counts, "differing": comparison[comparison["verdict"] == FAILS]}


def check_table(cases, checks):
    """The judged numbers of every run beside their bounds."""
    rows = [
        {
            "case": describe(case),
            "energy balance error [%]": 100 * result["energy_balance_error"],
            "bound [%]": 100 * result["bounds"]["energy_balance_error"],
            "largest overlap [d_p]": result["largest_overlap"],
            "bound [d_p]": result["bounds"]["largest_overlap"],
        }
        for case, result in zip(cases, checks, strict=True)
    ]
    return html_table(pandas.DataFrame(rows))


def smallness(particles):
    """A caution for grids smaller than the paper's."""
    if min(particles) >= PAPER_PARTICLES:
        return ""
    return (
        f"The paper has {PAPER_PARTICLES} particles and 390 particle diameters of layer: what a smaller grid cannot "
        'settle "cannot be told", and the table says what it would take.'
    )


def context(snakemake):
    """Everything the template shows."""
    inputs, params = snakemake.input, snakemake.params
    captions = yaml.safe_load(Path(inputs.captions).read_text())
    comparison = pandas.read_csv(inputs.comparison, dtype={"figure": str})
    files = {
        Path(bitmap).stem: (bitmap, sources) for bitmap, sources in zip(inputs.figures, inputs.sources, strict=True)
    }
    summaries = [read_json(path) for path in inputs.summaries]
    checks = [read_json(path) for path in inputs.checks]
    particles = sorted({summary["particles"] for summary in summaries})
    metrics = pandas.read_csv(inputs.metrics)
    verdicts = verdict_counts(comparison)
    return {
        "name": params.name,
        "date": datetime.datetime.now(datetime.timezone.utc).date().isoformat(),
        "paper": PAPER,
        "statements": verdicts["all"],
        "verdicts": verdicts["counts"],
        "differing": html_table(verdicts["differing"]) if len(verdicts["differing"]) else "",
        "layer_table": html_table(layer_rows(metrics)),
        "layers": sum(any(stage["name"] == "spread" for stage in summary["stages"]) for summary in summaries),
        "beds": len(summaries),
        "particles": listing(particles),
        "seeds": listing(sorted({summary["seed"] for summary in summaries})),
        "versions": listing(sorted({str(summary["version"]) for summary in summaries})),
        "smallness": smallness(particles),
        "figures": [figure_entry(name, captions, *files[name], comparison) for name in captions if name in files],
        "absent": [captions[name]["title"] for name in captions if name not in files],
        "mechanisms": html_table(statements_of(comparison, "section 5.5")),
        "energy_table": html_table(energy_rows(pandas.read_csv(inputs.energy))),
        "checks": listing(checks[0]["checks"]),
        "check_table": check_table(params.cases, checks),
        "beds_table": html_table(pandas.read_csv(inputs.beds)),
        "runtime_table": html_table(runtime_rows(pandas.read_csv(inputs.runtime))),
        "derived_table": html_table(derived_rows(pandas.read_csv(inputs.derived, dtype=str, keep_default_na=False))),
        "configuration": params.configuration,
    }


if __name__ == "__main__":
    with logged(snakemake):
        template = Path(snakemake.input.template)
        environment = jinja2.Environment(
            loader=jinja2.FileSystemLoader(template.parent), autoescape=True, undefined=jinja2.StrictUndefined
        )
        write_text(snakemake.output[0], environment.get_template(template.name).render(context(snakemake)))
