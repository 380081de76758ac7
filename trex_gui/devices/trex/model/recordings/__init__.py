"""Recording a board and playing a recording back."""
