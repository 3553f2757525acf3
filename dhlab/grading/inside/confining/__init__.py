"""What a submission may not do, by Linux's own calls; where one is missing the caller is told."""
