"""The report: one HTML page with every figure, caption and table in it."""

import base64
import re
from pathlib import Path

import jinja2
import pandas
import yaml
from markupsafe import Markup

from reporting import describe, logged, read_json, write_text

PAPER_PARTICLES = 100_000


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
        "width": (
            "column" if name in ("fig02_global_packing", "fig07_vertical_distribution", "fig13_roughness") else "page"
        ),
        "image": base64.b64encode(Path(bitmap).read_bytes()).decode(),
        "bonds": listing(drawn["bond_numbers"]),
        "ratios": listing(drawn["stiffness_ratios"]),
        "seeds": listing(drawn["seeds"]),
        "versions": listing(drawn["versions"]),
        "files": listing(drawn["files"]),
        "note": drawn["note"],
        "statements": html_table(mine) if first and len(mine) else "",
    }


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
        'settle is called "not testable" below.'
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
    return {
        "name": params.name,
        "layers": sum(any(stage["name"] == "spread" for stage in summary["stages"]) for summary in summaries),
        "beds": len(summaries),
        "particles": listing(particles),
        "seeds": listing(sorted({summary["seed"] for summary in summaries})),
        "versions": listing(sorted({str(summary["version"]) for summary in summaries})),
        "smallness": smallness(particles),
        "figures": [figure_entry(name, captions, *files[name], comparison) for name in captions if name in files],
        "absent": [captions[name]["title"] for name in captions if name not in files],
        "inertial_lengths": html_table(statements_of(comparison, "section 5.5")),
        "checks": listing(checks[0]["checks"]),
        "check_table": check_table(params.cases, checks),
        "beds_table": html_table(pandas.read_csv(inputs.beds)),
        "runtime_table": html_table(pandas.read_csv(inputs.runtime)),
        "derived_table": html_table(pandas.read_csv(inputs.derived, dtype=str, keep_default_na=False)),
        "configuration": params.configuration,
    }


if __name__ == "__main__":
    with logged(snakemake):
        template = Path(snakemake.input.template)
        environment = jinja2.Environment(
            loader=jinja2.FileSystemLoader(template.parent), autoescape=True, undefined=jinja2.StrictUndefined
        )
        write_text(snakemake.output[0], environment.get_template(template.name).render(context(snakemake)))
