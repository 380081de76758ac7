"""The Pololu TReX and TReX Jr dual motor controllers."""
