"""What an ERP system or a user attaches to a drawing or a job."""
