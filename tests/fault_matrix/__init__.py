import pytest

pytest.register_assert_rewrite("tests.fault_matrix.check")
