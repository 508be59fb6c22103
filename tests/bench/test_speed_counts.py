"""Counting operations and bytes from instructions: what an instruction does, and what a file of callgrind says."""

import textwrap

import pytest


@pytest.fixture(scope="module")
def counts(speed):
    return speed("counts")


@pytest.mark.parametrize(
    ("mnemonic", "operands", "operations"),
    [
        ("vaddpd", "ymm0,ymm1,ymm2", 4),
        ("vmulps", "ymm0,ymm1,YMMWORD PTR [rax]", 8),
        ("vfmadd213pd", "ymm0,ymm1,ymm2", 8),
        ("vfnmadd231sd", "xmm0,xmm1,QWORD PTR [rax]", 2),
        ("vsqrtpd", "xmm0,xmm1", 2),
        ("vdivsd", "xmm0,xmm1,xmm2", 1),
        ("mulps", "xmm0,xmm1", 4),
        ("vfmadd132pd", "zmm0,zmm1,zmm2", 16),
        ("vmovapd", "ymm0,YMMWORD PTR [rax]", 0),
        ("vmaxpd", "ymm0,ymm1,ymm2", 0),
        ("add", "rax,rbx", 0),
        ("vpaddq", "ymm0,ymm1,ymm2", 0),
    ],
)
def test_operations_count_once_for_each_lane(counts, mnemonic, operands, operations):
    assert counts.operations(mnemonic, operands) == operations


@pytest.mark.parametrize(("operands", "size"), [("ymm0,YMMWORD PTR [rax]", 32), ("DWORD PTR [rax+rbx*4],xmm1", 4), ("rbp", 8)])
def test_bytes_are_those_of_the_operand_in_memory(counts, operands, size):
    assert counts.bytes_of(operands) == size


def test_inclusive_costs_of_calls_are_not_counted_twice(counts, tmp_path):
    file = tmp_path / "callgrind.out"
    file.write_text(
        textwrap.dedent("""\
            positions: instr line
            events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw
            ob=/program
            fn=steps
            0x10 0 5 2 1 0 1 0 0 1 0
            calls=1 0x20 0
            0x14 0 100 50 50 0 0 0 0 0 0
            0x18 0 5 0 0 0 0 0 0 0 0
            ob=/library
            0x10 0 7 1 0 0 0 1 0 0 0
            """)
    )
    totals, found = counts.events(file)
    assert totals["Ir"] == 17 and totals["Dr"] == 3
    assert found["/program"][0x10]["Ir"] == 5 and found["/library"][0x10]["Ir"] == 7
    code = {0x10: ("vaddpd", "ymm0,ymm1,YMMWORD PTR [rax]"), 0x18: ("vfmadd213pd", "ymm0,ymm1,ymm2")}
    entries = counts.per_particle_step(totals, found, code, "/program", 5)
    # Five additions and five fused operations on four lanes; three operands of 32 bytes, one of the library taken as 8.
    assert entries["operations"] == (5 * 4 + 5 * 8) / 5 and entries["bytes_requested"] == (3 * 32 + 1 * 8) / 5
    assert entries["quotients_and_roots"] == 0
    assert counts.per_particle_step(totals, found, {0x10: ("vsqrtpd", "ymm0,ymm1")}, "/program", 5)["quotients_and_roots"] == 4
    assert counts.per_particle_step(totals, found, {0x10: ("vrsqrtps", "ymm0,ymm1")}, "/program", 5)["quotients_and_roots"] == 0
    assert entries["bytes_beyond_first_cache"] == 64 * 2 / 5 and entries["bytes_beyond_second_cache"] == pytest.approx(64 / 5)


def test_counts_stand_beside_those_of_the_same_case(speed):
    row = {"scene": "bed", "bond_number": 50, "precision": "mixed", "instructions": 450}
    former = [row | {"bond_number": 0}, row | {"precision": "", "instructions": 900}]
    assert "instructions 450 (0.500)" in speed("instructions").compared(row, former)
    assert "instructions 450" in speed("instructions").compared(row, []) and "(" not in speed("instructions").compared(row, [])
